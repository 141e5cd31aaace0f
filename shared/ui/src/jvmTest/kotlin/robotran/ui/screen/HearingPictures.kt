package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Writes pictures of the settings with the sounds of a run, to build/pictures for review. */
class HearingPictures {
    @Test
    fun `the sounds of a run can be photographed in all languages`() {
        for (language in Language.entries) {
            for (scale in listOf(1f, 2f)) {
                val workshop = runBlocking { openWorkshop() }
                val settings = Settings(textScale = scale, language = language, hearsRun = true)
                workshop.handle(SettingsEvent.SettingsChanged(settings))
                workshop.handle(SettingsEvent.SettingsShown(true))
                photograph(workshop, 412, 2_600).keepAs("hearing/${language.tag}-${scale.toInt()}")
                workshop.close()
            }
        }
    }
}
