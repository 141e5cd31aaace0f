package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.programs.messages.ProgramMessages

/** Tells that a program is for another kind of brick, at the place where it says so. */
internal class OtherBrick(private val robot: BrickKind, private val messages: ProgramMessages) {
    /** The mistake in [source] if it cannot run on the robot; null if it can. */
    fun errorIn(source: ProgramSource): Diagnostic? {
        val program = brickOf(source)?.takeIf { it != robot } ?: return null
        return diagnosticOf(source, messages.forOtherBrick(program, robot))
    }

    /** The mistake in [source] if it is not for an RCX with leJOS, which images are for. */
    fun errorInImage(source: ProgramSource): Diagnostic? {
        if (source.isForLegoFirmware) return diagnosticOf(source, messages.noImageForFirmware())
        val program = brickOf(source) ?: robot
        return if (program.java ==
            JavaPlatform.LEJOS
        ) {
            null
        } else {
            diagnosticOf(source, messages.noImageFor(program))
        }
    }

    private fun diagnosticOf(source: ProgramSource, message: String): Diagnostic {
        val mention = source.language?.support?.files?.brickMentionIn(source.files)
        return Diagnostic(Severity.ERROR, mention?.file ?: source.name, mention?.range, message)
    }
}
