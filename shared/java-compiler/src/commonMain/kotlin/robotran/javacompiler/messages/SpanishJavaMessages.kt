package robotran.javacompiler.messages

object SpanishJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by SpanishJavaSyntaxMessages,
    JavaNameMessages by SpanishJavaNameMessages,
    JavaSemanticMessages by SpanishJavaSemanticMessages,
    JavaClassMessages by SpanishJavaClassMessages,
    JavaLimitMessages by SpanishJavaLimitMessages,
    UnsupportedOnBrickMessages by SpanishBrickMessages,
    LejosMessages by SpanishLejosMessages,
    NxjMessages by SpanishNxjMessages
