package robotran.javacompiler.messages

object GermanJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by GermanJavaSyntaxMessages,
    JavaNameMessages by GermanJavaNameMessages,
    JavaSemanticMessages by GermanJavaSemanticMessages,
    JavaClassMessages by GermanJavaClassMessages,
    UnsupportedOnBrickMessages by GermanBrickMessages,
    LejosMessages by GermanLejosMessages,
    NxjMessages by GermanNxjMessages
