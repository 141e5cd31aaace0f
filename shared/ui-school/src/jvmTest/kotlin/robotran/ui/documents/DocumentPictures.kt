package robotran.ui.documents

import robotran.language.Language
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.documents.keep
import robotran.workshop.documents.projectFile
import robotran.workshop.documents.projects
import robotran.workshop.documents.write
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test

/** Writes pictures of the document dialogs to build/pictures for review. */
class DocumentPictures {
    @Test
    fun `all dialogs about the work can be photographed`() {
        for ((name, width, height) in SCREENS) {
            for (dark in listOf(false, true)) {
                val prefix = "documents-$name-${theme(dark)}"
                val picture = { what: String, workshop: Workshop ->
                    photograph(workshop, width, height, dark, "$prefix-$what")
                }
                val machine = Machine()
                val workshop = machine.window(OpenRequest.OfFiles(listOf(projectFile("forward 20\nbeep\n"))))
                workshop.handle(DocumentEvent.Renamed("The maze behind the house"))
                workshop.handle(ProgramEvent.ProgramEdited("forward 21\nbeep\n"))
                workshop.keep()
                picture("unsaved", workshop)
                workshop.handle(DocumentEvent.NewRequested)
                workshop.handle(DocumentEvent.Renamed("Line follower"))
                workshop.handle(ProgramEvent.ProgramEdited("forward 22\n"))
                workshop.handle(DocumentEvent.ProjectListRequested)
                picture("works", workshop)
                workshop.handle(DocumentEvent.LinkRequested)
                picture("link", workshop)
                workshop.handle(DocumentEvent.RenameRequested)
                picture("rename", workshop)
                workshop.handle(DocumentEvent.DialogClosed)
                machine.store.full = true
                workshop.handle(ProgramEvent.ProgramEdited("forward 23\n"))
                workshop.keep()
                picture("full", workshop)
                workshop.handle(DocumentEvent.NewRequested)
                picture("loss", workshop)
                workshop.close()
            }
        }
    }

    @Test
    fun `questions about work that stopped the app or is newer than its file can be photographed`() {
        for ((name, width, height) in SCREENS) {
            for (language in listOf(Language.ENGLISH, Language.GERMAN, Language.SPANISH)) {
                val picture = { what: String, workshop: Workshop ->
                    val settings = workshop.state.settings.copy(language = language)
                    workshop.handle(SettingsEvent.SettingsChanged(settings))
                    photograph(
                        workshop,
                        width,
                        height,
                        dark = language == Language.GERMAN,
                        "documents-$name-$what-$language",
                    )
                }
                val machine = Machine()
                val file = OpenRequest.OfFiles(listOf(projectFile("forward 20\nbeep\n")))
                machine.window(file).also { it.write("forward 21\nbeep\n") }
                picture("stopped", machine.afterKill().window())
                val later = machine.afterKill().also { it.marks.times.clear() }
                later.files.changed = 0
                picture("newer", later.window(file))
                val shared = Machine()
                shared.window().write("forward 7")
                val second = shared.window()
                val work = second.projects().single().entry.id
                second.handle(DocumentEvent.ProjectListRequested)
                second.handle(DocumentEvent.SavedProjectChosen(work))
                picture("elsewhere", second)
                picture("about", Machine().window().also { it.handle(DocumentEvent.AboutRequested("1.2")) })
                picture("silent", Machine().also { it.store.isAnswering = false }.window())
            }
        }
    }

    @Test
    fun `a link of this machine alone, and a file with remarks`() {
        for ((name, width, height) in SCREENS) {
            val workshop = Machine().also { it.page = "http://localhost:8282/" }.window()
            workshop.handle(DocumentEvent.LinkRequested)
            photograph(workshop, width, height, dark = false, "documents-$name-light-local-link")
            workshop.handle(DocumentEvent.DialogClosed)
            val old = OpenedFile("Karl.robo.txt", "beep // f\u00FCr\n".map { it.code.toByte() }.toByteArray())
            val text = BuiltInWorlds.texts.getValue("maze.world.json").replaceFirst("\"task\"", "\"tsk\"")
            val world = OpenedFile("maze.world.json", text.encodeToByteArray())
            workshop.handle(DocumentEvent.FilesBrought(listOf(old, world)))
            photograph(workshop, width, height, dark = false, "documents-$name-light-remarks")
            workshop.close()
        }
    }

    @Test
    fun `dialogs keep their words when text is twice as large, and in German`() {
        val machine = Machine()
        val workshop = machine.window()
        val settings = workshop.state.settings
        workshop.handle(SettingsEvent.SettingsChanged(settings.copy(language = Language.GERMAN, textScale = 2f)))
        workshop.handle(DocumentEvent.LinkRequested)
        photograph(workshop, width = 411, height = 891, dark = false, "documents-phone-german-200-link")
        workshop.handle(DocumentEvent.ProjectListRequested)
        photograph(workshop, width = 1280, height = 800, dark = false, "documents-tablet-german-200-works")
        workshop.handle(SettingsEvent.SettingsChanged(settings))
        photograph(workshop, width = 411, height = 891, dark = false, "documents-phone-usual-again")
        workshop.close()
    }

    private fun photograph(workshop: Workshop, width: Int, height: Int, dark: Boolean, name: String) =
        photograph(workshop, width, height, dark).keepAs("documents/$name")

    private fun theme(dark: Boolean) = if (dark) "dark" else "light"

    private companion object {
        val SCREENS = listOf(Triple("phone", 411, 891), Triple("tablet", 1280, 800))
    }
}
