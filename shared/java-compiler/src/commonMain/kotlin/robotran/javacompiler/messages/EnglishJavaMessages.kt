package robotran.javacompiler.messages

object EnglishJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by EnglishJavaSyntaxMessages,
    JavaNameMessages by EnglishJavaNameMessages,
    JavaSemanticMessages by EnglishJavaSemanticMessages,
    JavaClassMessages by EnglishJavaClassMessages,
    JavaLimitMessages by EnglishJavaLimitMessages,
    UnsupportedOnBrickMessages by EnglishBrickMessages,
    LejosMessages by EnglishLejosMessages,
    NxjMessages by EnglishNxjMessages
