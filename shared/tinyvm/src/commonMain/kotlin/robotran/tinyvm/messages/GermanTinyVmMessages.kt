package robotran.tinyvm.messages

/**
 * What the virtual machine says in German. One thing has one word: array - Array, brick - Stein, class - Klasse, field
 * - Feld, method - Methode, memory - Speicher, thread - Thread.
 */
object GermanTinyVmMessages :
    TinyVmMessages,
    ClassFileMessages by GermanClassFileMessages,
    LinkMessages by GermanLinkMessages,
    RunMessages by GermanVmRunMessages

private object GermanClassFileMessages : ClassFileMessages {
    override fun notAClassFile() = "Das ist keine Klassendatei: Übersetz das Programm noch einmal."

    override fun classFileTooLong(limit: Int) =
        "Diese Klassendatei ist länger als $limit Bytes. In einen Stein passt viel weniger."

    override fun classFileTooNew() =
        "Diese Klasse wurde für ein neueres Java übersetzt, als ein Stein versteht. Übersetz sie mit --release 8, " +
            "oder öffne hier ihren Quelltext."

    override fun classFileDamaged() = "Diese Klassendatei ist beschädigt: Übersetz das Programm noch einmal."
}
