package robotran.tinyvm.messages

/**
 * What the virtual machine says in Spanish. One thing has one word: array - array, brick - ladrillo, class - clase,
 * field - campo, method - método, memory - memoria, thread - hilo.
 */
object SpanishTinyVmMessages :
    TinyVmMessages,
    ClassFileMessages by SpanishClassFileMessages,
    LinkMessages by SpanishLinkMessages,
    RunMessages by SpanishVmRunMessages

private object SpanishClassFileMessages : ClassFileMessages {
    override fun notAClassFile() = "Este no es un archivo de clase: compila el programa otra vez."

    override fun classFileTooLong(limit: Int) =
        "Este archivo de clase tiene más de $limit bytes. En un ladrillo cabe mucho menos."

    override fun classFileTooNew() =
        "Esta clase se ha compilado para un Java más nuevo que el que entiende un ladrillo. Compílala con --release " +
            "8, o abre aquí su texto."

    override fun classFileDamaged() = "Este archivo de clase está dañado: compila el programa otra vez."
}
