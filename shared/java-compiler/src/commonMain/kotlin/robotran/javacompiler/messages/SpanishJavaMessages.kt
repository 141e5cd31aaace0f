package robotran.javacompiler.messages

/**
 * The messages in Spanish. They call the pupil "tú". One thing has one word: array - array, braces - llaves, brackets -
 * paréntesis, brick - ladrillo, class - clase, declare - declarar, field - campo, loop - bucle, method - método, text -
 * texto, type - tipo, value - valor.
 */
object SpanishJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by SpanishJavaSyntaxMessages,
    JavaNameMessages by SpanishJavaNameMessages,
    JavaMeaningMessages by SpanishJavaMeaningMessages,
    JavaClassMessages by SpanishJavaClassMessages,
    UnsupportedOnBrickMessages by SpanishBrickMessages
