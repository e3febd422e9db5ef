namespace A { struct S { float x; }; S s; texture t; SamplerState u { Filter = LINEAR; }; namespace B { float f(A::S q) { return q.x + ::A::s.x; } } }
interface I { float g(float x); }; struct J : I { float k; float g(float x) { return k * x; } }; J j; I is[];
float4 P(float2 p : TEXCOORD0) : COLOR { float4 r; asm { tfetch2D r, p, t }; [isolate] { r.x += is[0].g(A::B::f(A::s)) + is.length; } float2 a; float4(a, r.zw) = A::t.Sample(A::u, p); return r; }
float4 Q(float2 p : TEXCOORD0) : COLOR { float x[4] = (float[4])A::t.SampleLevel(A::u, p, 1); return x[2]; }
technique T { pass { PixelShader = compile ps_4_0 P(); } } technique U { pass { PixelShader = compile ps_4_0 Q(); } }
