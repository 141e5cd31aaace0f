package robotran.javacompiler.messages

/**
 * The messages in German. They call the pupil "du". One thing has one word: array - Array, braces - geschweifte
 * Klammern, brackets - Klammern, brick - Stein, class - Klasse, declare - anlegen, field - Feld, loop - Schleife,
 * method - Methode, text - Text, type - Typ, value - Wert.
 */
object GermanJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by GermanJavaSyntaxMessages,
    JavaNameMessages by GermanJavaNameMessages,
    JavaMeaningMessages by GermanJavaMeaningMessages,
    JavaClassMessages by GermanJavaClassMessages,
    UnsupportedOnBrickMessages by GermanBrickMessages
