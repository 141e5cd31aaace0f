package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.TimedCompilation
import robotran.projects.PENBOT_TARGET
import robotran.projects.penbotTarget
import robotran.simulation.RobotProgramSet
import robotran.ui.programlanguages.ExampleSet
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures
import robotran.world.file.BuiltInWorlds

/**
 * Thumbnails of what the examples draw. A Java program shows the drawing of its Robolang version, since compiling it
 * takes longer; a program without one is compiled.
 */
object ExamplePictures : CardPictures<String> {
    private val pictures = SheetPictures()
    private val compiler = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)

    override fun ready(subject: String, colours: SheetColours, room: PictureBounds): ImageBitmap? =
        pictures.ready(twinOf(subject) ?: subject, colours, room)

    /** The thumbnail of the example [subject]. If the compiler cannot be loaded, shows the sheet before the run. */
    override suspend fun of(subject: String, colours: SheetColours, room: PictureBounds): ImageBitmap {
        val id = twinOf(subject) ?: subject
        val (set, name) = ExampleSet.find(id) ?: (ExampleSet.ROBOLANG to id)
        val brick = set.brick ?: BrickKind.default
        return pictures.of(id, BuiltInWorlds.plainFor(brick), colours, room) {
            listOfNotNull(programOf(set, name, brick)).map { RobotProgramSet(listOf(it)) }
        }
    }

    private suspend fun programOf(set: ExampleSet, name: String, brick: BrickKind): BrickProgram? {
        val text = set.programs[name] ?: return null
        val source = Program(name, set.language, text)
        val compiled = compiler.forTarget(brick.penbotTarget).compile(source) as? TimedCompilation.Compiled
        return (compiled?.result as? ProgramResult.Success)?.program
    }

    /** The Robolang version of a Java example for an RCX: `wall-bouncer.robo` for `WallBouncer.java`. */
    private fun twinOf(id: String): String? = ExampleSet.ROBOLANG.programs.keys.firstOrNull {
        it == id || it.replace("-", "").removeSuffix(".robo") == id.lowercase().removeSuffix(".java")
    }
}
