package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import robotran.programs.ProgramReader
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.ui.exampleTexts
import robotran.ui.sheet.PictureRoom
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures
import robotran.ui.workshop.PENBOT_CALIBRATION
import robotran.world.BuiltInWorlds

/** Small pictures of what the examples draw. A Java program shows what its twin in Robolang draws, since compiling it takes longer than looking at it. */
internal object ExamplePictures {
    private val pictures = SheetPictures()
    private val reader = ProgramReader(PENBOT_CALIBRATION)

    /** The picture of the example [name] if it has been drawn, see [SheetPictures.ready]. */
    fun ready(name: String, colours: SheetColours, room: PictureRoom): ImageBitmap? = pictures.ready(twinOf(name).orEmpty(), colours, room)

    /** The picture of the example [name], drawn if it was not; of an empty sheet for one that has no twin. */
    suspend fun of(name: String, colours: SheetColours, room: PictureRoom): ImageBitmap {
        val twin = twinOf(name) ?: return pictures.of("", BuiltInWorlds.plain, colours, room)
        return pictures.of(twin, BuiltInWorlds.plain, colours, room) {
            val read = reader.readNow(ProgramSource.Robolang(twin, exampleTexts.getValue(twin)))
            (read as? ProgramResult.Ready)?.program
        }
    }

    /** The example in Robolang that does the same as the example [name]: `wall-bouncer.robo` for `WallBouncer.java`. */
    private fun twinOf(name: String): String? =
        exampleTexts.keys.firstOrNull { it == name || it.replace("-", "").removeSuffix(".robo") == name.lowercase().removeSuffix(".java") }
}
