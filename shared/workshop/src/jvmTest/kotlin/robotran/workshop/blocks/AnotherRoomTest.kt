package robotran.workshop.blocks

import kotlinx.coroutines.runBlocking
import robotran.projects.ProgramView
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

class AnotherRoomTest {
    @Test
    fun `what is open over the blocks closes when another room opens, and stays beside help and panes`() {
        val toRooms = listOf(
            LearningEvent.PageRequested(LearningPage.MAP),
            LearningEvent.PageRequested(LearningPage.TUTORIAL),
            LearningEvent.PageRequested(LearningPage.WORLDS),
            SettingsEvent.SettingsShown(true),
            WorldEditEvent.EditorOpened,
        )
        val stays = listOf(LearningEvent.PageRequested(LearningPage.HELP), ScreenEvent.PaneChosen(Pane.WORLD))
        for (event in toRooms + stays) {
            val workshop = runBlocking { openWorkshop() }
            workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
            workshop.handle(BlockEvent.DialogShown(BlockDialog.Palette))
            assertNotNull(workshop.state.programs.blocks?.sheet)
            val text = workshop.state.programText
            workshop.handle(event)
            assertEquals(event in stays, workshop.state.programs.blocks?.sheet != null, "$event")
            assertEquals(text, workshop.state.programText)
            workshop.close()
        }
    }
}
