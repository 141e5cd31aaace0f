package robotran.javacompiler.messages

import robotran.language.quoted

internal object GermanJavaLimitMessages : JavaLimitMessages {
    override fun sourceTooLong(limit: String) =
        "Ein Programm kann höchstens $limit Zeichen und 100 Dateien haben. Von diesem wurde nichts gelesen."

    override fun nestedTooDeeply() =
        "Hier steht zu viel ineinander. Nimm für einen Teil eine Methode oder eine Variable."

    override fun tooManyImports(limit: String) =
        "Eine Datei kann höchstens $limit Importe haben. Einer mit \".*\" am Ende gilt für alle Klassen eines Pakets."

    override fun tooManyClasses(limit: String) = "Ein Programm kann höchstens $limit Klassen haben."

    override fun finallyCopiedTooOften() =
        "Der Compiler kopiert, was in einem \"finally\" steht, an jedes Ende seines \"try\". Hier werden es zu viele " +
            "Kopien von Kopien."

    override fun useMethodInFinally() =
        "Schreib das, was in diesem \"finally\" steht, in eine Methode, und ruf sie darin auf."

    override fun tooMuchWork(name: String) = "Der Compiler würde für ${quoted(name)} zu lange brauchen."

    override fun putLessInside() = "Teil es auf, und schreib weniger ineinander."

    override fun methodTooLong() =
        "Das ergibt mehr Befehle, als in eine Methode passen; das sind 65535 Bytes. Teil es auf mehrere Methoden auf."
}
