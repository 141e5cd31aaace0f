package robotran.workshop.run

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Settings
import robotran.workshop.state.SheetWords
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertIs
import kotlin.test.assertSame

class RunToldTest {
    private val workshop = runBlocking { openWorkshop() }
    private var now = 0L

    @AfterTest
    fun close() = workshop.close()

    private fun settings(change: Settings.() -> Settings) =
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.change()))

    private fun frames() = repeat(600) {
        now += 16_666_667
        workshop.frame(now)
    }

    @Test
    fun `other words of a program or on blocks do not make a run told again`() {
        settings { copy(language = Language.GERMAN, tellsRuns = true) }
        workshop.handle(ProgramEvent.ProgramEdited("pen down\nforward 41"))
        workshop.handle(RunEvent.RunPressed)
        frames()
        val told = assertIs<SheetWords.Told>(workshop.state.sheet.words)
        settings { copy(hasEnglishWords = true) }
        frames()
        assertSame(told, workshop.state.sheet.words)
        settings { copy(hasEnglishWords = false) }
        frames()
        assertSame(told, workshop.state.sheet.words)
        workshop.handle(ProgramEvent.ProgramEdited("stift runter\nvorwärts 41"))
        frames()
        assertSame(told, workshop.state.sheet.words)
    }
}
