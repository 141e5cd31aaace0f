package robotran.ui.worldedit

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Settings
import robotran.world.geometry.Point
import robotran.worldediting.PaletteItem
import robotran.worldediting.WorldEdit
import robotran.worldediting.piece
import kotlin.test.Test

/** Writes pictures of the world editor to build/pictures for review. */
class EditPictures {
    @Test
    fun `the editor can be photographed in every size, by day and by night`() {
        for ((name, width, height) in SCREENS) {
            for (theme in listOf(AppTheme.LIGHT, AppTheme.DARK, AppTheme.HIGH_CONTRAST)) {
                photograph(width, height, Settings(theme = theme), "edit-$name-${theme.name.lowercase()}")
            }
        }
    }

    @Test
    fun `German and text at twice its size can be photographed`() {
        for ((name, width, height) in SCREENS) {
            photograph(width, height, Settings(language = Language.GERMAN), "edit-$name-german")
            photograph(width, height, Settings(textScale = 2f), "edit-$name-large")
        }
    }

    private fun photograph(width: Int, height: Int, settings: Settings, name: String) {
        val workshop = runBlocking { openWorkshop() }
        workshop.handle(SettingsEvent.SettingsChanged(settings))
        workshop.handle(WorldEditEvent.EditorOpened)
        build(workshop)
        photograph(workshop, width, height).keepAs("worldedit/$name")
        workshop.close()
    }

    private fun build(workshop: Workshop) {
        fun make(edit: WorldEdit) = workshop.handle(WorldEditEvent.Edited(edit))

        fun put(item: PaletteItem, x: Double, y: Double) =
            make(WorldEdit.Put(item.piece(checkNotNull(workshop.state.worldEdit).world), Point(x, y)))
        put(PaletteItem.LINE, 70.0, 20.0)
        put(PaletteItem.GOAL_AREA, 85.0, 65.0)
        put(PaletteItem.LAMP, 20.0, 60.0)
        put(PaletteItem.BLOCK, 20.0, 15.0)
        put(PaletteItem.ROBOT, 70.0, 35.0)
        put(PaletteItem.BOX, 45.0, 62.0)
        make(WorldEdit.TurnBy(15.0))
    }

    private companion object {
        val SCREENS = listOf(
            Triple("phone", 411, 891),
            Triple("tablet", 1280, 800),
            Triple("upright", 820, 1180),
            Triple("laptop", 1440, 900),
        )
    }
}
