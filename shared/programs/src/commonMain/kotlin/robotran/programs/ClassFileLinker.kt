package robotran.programs

import robotran.robolang.diagnostic.SourceRange
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.linkTinyVm
import robotran.tinyvm.messages.TinyVmMessages

/** Links class files from our own compiler or another one. */
internal class ClassFileLinker(private val settings: JavaSettings, private val messages: TinyVmMessages) {
    /** Links what another compiler made, unless it uses what the brick that it is for does not have. */
    fun read(source: ProgramSource.CompiledClasses, gaps: CompiledGaps): ProgramResult {
        val result = link(source.name, source.classFiles, source.mainClass) { it.sourceFile }
        val mistakes = if (result is ProgramResult.Ready) gaps.find(source.classFiles) else emptyList()
        return if (mistakes.isEmpty()) result else ProgramResult.HasErrors(mistakes)
    }

    /** @param fileOf returns the source file of the class in a link error; null if it is unknown. */
    fun link(
        name: String,
        classFiles: Map<String, ByteArray>,
        mainClass: String?,
        fileOf: (LinkError) -> String?,
    ): ProgramResult {
        val result = linkTinyVm(
            name,
            classFiles,
            BrickLibrary.classFilesFor(settings),
            mainClass,
            settings.mode,
            messages,
            settings.speed,
        )
        return when (result) {
            is TinyVmResult.Ready -> ProgramResult.Ready(result.program)

            is TinyVmResult.Rejected -> ProgramResult.HasErrors(
                listOf(diagnosticOf(result.refusal, fileOf(result.refusal))),
            )
        }
    }

    private fun diagnosticOf(refusal: LinkError, file: String?): ProgramDiagnostic {
        val place = listOfNotNull(refusal.className.ifEmpty { null }, refusal.methodName).joinToString(".")
        val line = refusal.sourceLine.takeIf { it > 0 }
        return ProgramDiagnostic(
            file = file ?: place,
            range = line?.let { SourceRange(it, FIRST_COLUMN, FIRST_COLUMN) },
            message = if (file == null || place.isEmpty()) refusal.message else "$place: ${refusal.message}",
        )
    }

    private companion object {
        /** A class file has line numbers, but no columns. */
        const val FIRST_COLUMN = 1
    }
}
