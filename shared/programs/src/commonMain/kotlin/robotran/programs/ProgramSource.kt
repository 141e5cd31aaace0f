package robotran.programs

import robotran.language.ProgramLanguage

/** The files of a pupil's program. */
sealed interface ProgramSource {
    /** The program's name, usually the name of its first file. */
    val name: String

    /** The language of its [files]; null for what another compiler made. */
    val language: ProgramLanguage?

    /** Its texts, the first one first; empty for what another compiler made. */
    val files: List<SourceFile>

    /** A program in Robolang, which always has one file. */
    data class Robolang(override val name: String, val text: String) : ProgramSource {
        override val language get() = ProgramLanguage.ROBOLANG
        override val files get() = listOf(SourceFile(name, text))
    }

    /**
     * A program in Java, for leJOS on an RCX or for leJOS NXJ on an NXT.
     *
     * @property files one or more source files. The main class is the class of the first file if it has a main method,
     * or else the first class that has one.
     */
    data class Java(override val name: String, override val files: List<SourceFile>) : ProgramSource {
        override val language get() = ProgramLanguage.JAVA
    }

    /**
     * A program in Java that was compiled elsewhere.
     *
     * @property classFiles the contents of its class files by file name.
     * @property mainClass the main class, with slashes; null for the first class with a main method.
     */
    class CompiledClasses(
        override val name: String,
        val classFiles: Map<String, ByteArray>,
        val mainClass: String? = null,
    ) : ProgramSource {
        override val language get() = null
        override val files get() = emptyList<SourceFile>()
    }

    /** A program for LEGO's own firmware of the RCX. */
    sealed interface ForLegoFirmware : ProgramSource

    /**
     * A program in NQC.
     *
     * @property files the program, then the files that it or these include, by the part of their names after the folders.
     */
    data class Nqc(override val name: String, override val files: List<SourceFile>) : ForLegoFirmware {
        override val language get() = ProgramLanguage.NQC
    }

    /** A program in assembly text. */
    data class Lasm(override val name: String, val text: String) : ForLegoFirmware {
        override val language get() = ProgramLanguage.LASM
        override val files get() = listOf(SourceFile(name, text))
    }

    /**
     * A program that was compiled elsewhere.
     *
     * @property bytes of its `.rcx` file.
     */
    class FirmwareImage(override val name: String, val bytes: ByteArray) : ForLegoFirmware {
        override val language get() = null
        override val files get() = emptyList<SourceFile>()
    }

    companion object {
        /** The program of [files], which are one if [language] knows no more. */
        fun of(language: ProgramLanguage, name: String, files: List<SourceFile>): ProgramSource = when (language) {
            ProgramLanguage.ROBOLANG -> Robolang(name, files.single().text)
            ProgramLanguage.JAVA -> Java(name, files)
            ProgramLanguage.NQC -> Nqc(name, files)
            ProgramLanguage.LASM -> Lasm(name, files.single().text)
        }
    }
}

/**
 * One file of a program.
 *
 * @property name its name, with or without folders, such as `Square.java`; it must match a public class in the file.
 * @property text its content, with any line breaks.
 */
data class SourceFile(val name: String, val text: String)

/** The name of a file without its folders. */
internal fun simpleName(path: String): String = path.substringAfterLast('/').substringAfterLast('\\')
