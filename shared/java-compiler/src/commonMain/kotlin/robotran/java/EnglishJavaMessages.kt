package robotran.java

/** The messages in English. */
object EnglishJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by EnglishJavaSyntaxMessages,
    JavaNameMessages by EnglishJavaNameMessages,
    JavaMeaningMessages by EnglishJavaMeaningMessages,
    JavaClassMessages by EnglishJavaClassMessages,
    BrickMessages by EnglishBrickMessages

/** [text] between quotation marks, unless it has one itself. */
internal fun quoted(text: String) = if ('"' in text) text else "\"$text\""
