package robotran.javacompiler.messages

import robotran.language.quoted

internal object EnglishJavaLimitMessages : JavaLimitMessages {
    override fun sourceTooLong(limit: String) =
        "A program can have at most $limit characters and 100 files. Nothing of it was read."

    override fun nestedTooDeeply() = "Too much is inside each other here. Use a method or a variable for a part."

    override fun tooManyImports(limit: String) =
        "A file can have at most $limit imports. An import that ends in \".*\" is for all classes of a package."

    override fun tooManyClasses(limit: String) = "A program can have at most $limit classes."

    override fun finallyCopiedTooOften() =
        "The compiler copies what is in a \"finally\" to each end of its \"try\". Here are too many copies of copies."

    override fun useMethodInFinally() = "Put what is in this \"finally\" into a method, and call that."

    override fun tooMuchWork(name: String) = "The compiler would need too long for ${quoted(name)}."

    override fun putLessInside() = "Divide it into several parts, and put less inside each other."

    override fun methodTooLong() =
        "This makes more instructions than fit into a method, which are 65535 bytes. Divide it into several methods."
}
