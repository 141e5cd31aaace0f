package robotran.tinyvm.messages

/** What the virtual machine says in English. */
object EnglishTinyVmMessages :
    TinyVmMessages,
    ClassFileMessages by EnglishClassFileMessages,
    LinkMessages by EnglishLinkMessages,
    RunMessages by EnglishVmRunMessages

private object EnglishClassFileMessages : ClassFileMessages {
    override fun notAClassFile() = "This is not a class file: compile the program again."

    override fun classFileTooLong(limit: Int) = "This class file is longer than $limit bytes. A brick holds far less."

    override fun classFileTooNew() =
        "This class was compiled for a newer Java than a brick understands. Compile it with --release 8, or open its " +
            "source here."

    override fun classFileDamaged() = "This class file is damaged: compile the program again."
}
