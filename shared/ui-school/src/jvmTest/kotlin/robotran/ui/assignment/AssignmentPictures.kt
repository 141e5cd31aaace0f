package robotran.ui.assignment

import robotran.assignments.doing.HandedInWork
import robotran.assignments.doing.makeHandIn
import robotran.assignments.doing.pupilCopy
import robotran.language.Language
import robotran.projects.Assignment
import robotran.projects.AssignmentPicture
import robotran.projects.Feedback
import robotran.projects.FeedbackResult
import robotran.projects.Project
import robotran.qrcode.QrCode
import robotran.ui.documents.LargeQrCode
import robotran.ui.pictures.sheetPng
import robotran.ui.screen.keepAs
import robotran.ui.screen.onEventThread
import robotran.ui.screen.photograph
import robotran.ui.screen.sceneOf
import robotran.ui.theme.RobotranTheme
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.documents.Machine
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.io.encoding.Base64
import kotlin.test.Test

/** Pictures of all that pupils and authors see of an assignment, for review. */
class AssignmentPictures {
    @Test
    fun `what pupils see, on all screens, dark, in German and with text twice as large`() {
        for (screen in Screen.entries) {
            for ((look, settings) in LOOKS) {
                for ((step, prepare) in PUPIL) {
                    picture(pupils, screen.width, screen.height, settings, prepare)
                        .keepAs("assignment/${screen.name.lowercase()}-$look-$step")
                }
            }
        }
    }

    @Test
    fun `the code for a class and the banner of the world editor`() {
        val code = checkNotNull(QrCode.of("https://school.example/" + "a".repeat(400)))
        for ((width, height) in listOf(360 to 740, 1024 to 768, 768 to 1024, 1280 to 800)) {
            for ((look, settings) in LOOKS) {
                picture(AnyAssignment.teachers, width, height, settings) {
                    handle(AssignmentEvent.MakingRequested)
                    handle(AssignmentEvent.VariationOpened(0))
                }.keepAs("assignment/variation-$width-$look")
                picture(AnyAssignment.teachers, width, height, settings) {
                    handle(ScreenEvent.TaskShown(true))
                }.keepAs("assignment/teacher-$width-$look")
            }
            val large = onEventThread {
                val scene = sceneOf(width, height) { RobotranTheme { LargeQrCode(code) {} } }
                try {
                    scene.render()
                    scene.render(nanoTime = 1_000_000_000)
                } finally {
                    scene.close()
                }
            }
            large.keepAs("assignment/qr-large-$width")
        }
    }

    @Test
    fun `what authors see, the whole page at once`() {
        for ((name, width) in listOf("phone" to 360, "tablet" to 1024)) {
            for ((look, settings) in LOOKS) {
                val height = if (look == "200") 9_000 else 4_800
                for ((step, prepare) in AUTHOR) {
                    picture(AnyAssignment.teachers, width, height, settings, prepare)
                        .keepAs("assignment/$name-$look-$step")
                }
            }
        }
    }

    private val pupils = pupilCopy(AnyAssignment.teachers.copy(assignment = withPicture()))

    /** The text with a picture of some size: the sheet of an empty project. */
    private fun withPicture(): Assignment {
        val empty = Machine().window()
        val picture = sheetPng(empty.state.world, empty.state.session)
        empty.close()
        return AnyAssignment.assignment.copy(pictures = listOf(AssignmentPicture("dot", Base64.encode(picture))))
    }

    private fun picture(project: Project, width: Int, height: Int, settings: Settings, prepare: Workshop.() -> Unit) =
        Machine().apply { files.location = "/home/ada.robotran" }.window(AnyAssignment.request(project)).run {
            try {
                handle(SettingsEvent.SettingsChanged(settings.copy(site = "https://school.example/")))
                handle(ScreenEvent.PaneChosen(Pane.WORLD))
                prepare()
                photograph(this, width, height)
            } finally {
                close()
            }
        }

    private enum class Screen(val width: Int, val height: Int) {
        PHONE(360, 740),
        PHONE_ACROSS(640, 360),
        TABLET_UPRIGHT(768, 1024),
        TABLET(1024, 768),
        LAPTOP(1280, 800),
    }

    private companion object {
        val LOOKS = mapOf(
            "light" to Settings(lessMotion = true),
            "dark" to Settings(lessMotion = true, theme = AppTheme.DARK),
            "german" to Settings(lessMotion = true, language = Language.GERMAN),
            "200" to Settings(lessMotion = true, textScale = 2f),
        )

        fun Workshop.attempt(text: String) {
            handle(ProgramEvent.ProgramEdited(text))
            handle(RunEvent.RunPressed)
            advance(20_000)
            handle(ScreenEvent.PaneChosen(Pane.WORLD))
        }

        fun Workshop.handIn() {
            attempt(AnyAssignment.SOLUTION)
            handle(AssignmentEvent.HandInRequested)
            handle(AssignmentEvent.NameEntered("Ada, 7b"))
        }

        val PUPIL: Map<String, Workshop.() -> Unit> = mapOf(
            "opened" to {},
            "failed" to { attempt("beep\n") },
            "hint" to {
                attempt("beep\n")
                handle(ScreenEvent.TaskShown(true))
            },
            "solved" to { attempt(AnyAssignment.SOLUTION) },
            "not-allowed" to {
                val strict = checkNotNull(project.assignment).copy(words = listOf("forward"))
                services.editor.openProject(project.copy(assignment = strict))
                handle(ProgramEvent.ProgramEdited("forward 5\nturn left 90\nbeep\nrepeat 3 times\n  beep\nend\n"))
                handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
            },
            "begun-again" to {
                attempt("forward 3\n")
                handle(AssignmentEvent.BegunAgain)
            },
            "asking-first" to { handle(AssignmentEvent.HandInRequested) },
            "asking" to {
                handIn()
                handle(AssignmentEvent.HandInClosed)
                handle(ProgramEvent.ProgramEdited("forward 20\n"))
                handle(AssignmentEvent.HandInRequested)
            },
            "ready" to {
                handIn()
                handle(AssignmentEvent.HandInMade())
                handle(AssignmentEvent.HandInFileSaved)
            },
            "feedback" to {
                attempt(AnyAssignment.SOLUTION)
                val best = checkNotNull(project.tries?.best)
                val handIn = makeHandIn(project, "Ada", HandedInWork(best))
                val results = listOf(FeedbackResult("", 3, 3), FeedbackResult("Small", 2, 3))
                services.editor.openProject(
                    handIn.copy(feedback = Feedback("Well done. Look at the small world again.", results)),
                )
            },
        )

        val AUTHOR: Map<String, Workshop.() -> Unit> = mapOf(
            "make" to {
                handle(AssignmentEvent.MakingRequested)
                handle(AssignmentEvent.CheckRequested(on = true))
                handle(AssignmentEvent.PupilFileSaved)
                handle(AssignmentEvent.PupilLinkRequested)
            },
            "make-empty" to {
                handle(AssignmentEvent.MakingRequested)
                handle(AssignmentEvent.Removed)
                handle(AssignmentEvent.MakingRequested)
                handle(AssignmentEvent.TaskChanged("", ""))
                handle(AssignmentEvent.PupilLinkRequested)
            },
        )
    }
}
