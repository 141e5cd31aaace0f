package robotran.javacompiler.messages

/** The messages in English. */
object EnglishJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by EnglishJavaSyntaxMessages,
    JavaNameMessages by EnglishJavaNameMessages,
    JavaMeaningMessages by EnglishJavaMeaningMessages,
    JavaClassMessages by EnglishJavaClassMessages,
    UnsupportedOnBrickMessages by EnglishBrickMessages
