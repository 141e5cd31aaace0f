package robotran.javacompiler.messages

object GermanJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by GermanJavaSyntaxMessages,
    JavaNameMessages by GermanJavaNameMessages,
    JavaSemanticMessages by GermanJavaSemanticMessages,
    JavaClassMessages by GermanJavaClassMessages,
    JavaLimitMessages by GermanJavaLimitMessages,
    UnsupportedOnBrickMessages by GermanBrickMessages,
    LejosMessages by GermanLejosMessages,
    NxjMessages by GermanNxjMessages
