package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.learning.Lessons
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.service.asProject
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Settings
import robotran.world.Goal
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.Reach
import robotran.world.Template
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.test.Test

/** Writes pictures of what was missing and of solved tasks to build/pictures for review. */
class OutcomePictures {
    @Test
    fun `what was missing can be photographed`() {
        missing().use("missing-phone", 411, 891)
        missing().use("missing-tablet", 1280, 800)
        missing().use("missing-laptop-dark", 1440, 900, dark = true)
        missing(Settings(language = Language.GERMAN)).use("missing-tablet-german", 1280, 800)
        missing(Settings(language = Language.GERMAN, textScale = 2f)).use("missing-phone-large", 411, 891)
        missing(tab = DrawerTab.GOALS).use("missing-goals-tablet", 1280, 800)
        missing(tab = DrawerTab.GOALS).use("missing-goals-phone", 411, 891)
        missing().apply {
            handle(RunEvent.ShortfallShown(state.run.shortfalls.first().shortfall))
            repeat(5) { frame(it * 16_000_000L) }
        }.use("missing-shown-tablet", 1280, 800)
    }

    @Test
    fun `what was missing in a lesson can be photographed on a small phone with large text`() {
        for ((width, height) in listOf(360 to 640, 360 to 780, 390 to 844)) {
            workshop(Settings(language = Language.GERMAN, textScale = 2f)).apply {
                handle(LearningEvent.TutorialStarted)
                handle(ProgramEvent.ProgramEdited("forward 10\n"))
                handle(LearningEvent.TutorialFolded(true))
                handle(RunEvent.RunPressed)
                advance(20_000)
            }.use("missing-lesson-$width-$height", width, height)
        }
    }

    @Test
    fun `a solved task can be photographed`() {
        solved().use("solved-phone", 411, 891)
        solved().use("solved-small-phone", 360, 640)
        solved(Settings(language = Language.GERMAN)).use("solved-small-phone-german", 360, 640)
        solved(Settings(language = Language.GERMAN, textScale = 2f)).use("solved-small-phone-large", 360, 640)
        solved().use("solved-tablet", 1280, 800)
        solved(Settings(language = Language.GERMAN, textScale = 2f)).use("solved-tablet-large", 1280, 800)
        solved().use("solved-laptop-dark", 1440, 900, dark = true)
    }

    @Test
    fun `what works here, and what fails there, can be photographed`() {
        for (isThere in listOf(false, true)) {
            val name = if (isThere) "there" else "here"
            elsewhere(isThere).apply { handle(LearningEvent.TutorialFolded(true)) }.use("again-$name-phone", 411, 891)
            elsewhere(isThere).use("again-$name-tablet", 1280, 800)
            elsewhere(isThere).use("again-$name-tablet-dark", 1280, 800, dark = true)
            val large = Settings(language = Language.GERMAN, textScale = 2f)
            elsewhere(isThere, large).use("again-$name-tablet-large", 1280, 800)
            elsewhere(isThere, large).apply { handle(LearningEvent.TutorialFolded(true)) }
                .use("again-$name-phone-large", 411, 891)
        }
    }

    private fun elsewhere(isThere: Boolean, settings: Settings = Settings()) = workshop(settings).apply {
        handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "edge" }))
        handle(ProgramEvent.ProgramEdited("wait 0.1 seconds\nforward 46\nbeep\n"))
        handle(RunEvent.RunPressed)
        advance(20_000)
        if (isThere) handle(LearningEvent.OtherPlaceTried)
        advance(20_000)
    }

    @Test
    fun `a robot that has left the paper can be photographed`() {
        strayed().use("strayed-phone", 411, 891)
        strayed().use("strayed-tablet", 1280, 800)
        strayed().use("strayed-laptop-dark", 1440, 900, dark = true)
    }

    private fun strayed(): Workshop = workshop(Settings()).apply {
        handle(LearningEvent.TutorialStarted)
        handle(ProgramEvent.ProgramEdited("forward 30\nturn left 60\nforward 300\n"))
        handle(LearningEvent.TutorialFolded(true))
        handle(RunEvent.RunPressed)
        advance(8_000)
    }

    private fun missing(settings: Settings = Settings(), tab: DrawerTab? = null): Workshop = workshop(settings).apply {
        val square = listOf(Point(40.0, 30.0), Point(60.0, 30.0), Point(60.0, 50.0), Point(40.0, 50.0))
        val goals = listOf(
            Goal(Reach(Shape.Rectangle(Point(85.0, 65.0), 16.0, 16.0))),
            Goal(DrawTemplate(excess = 2.0)),
            Goal(NeverTouch()),
        )
        val world = BuiltInWorlds.plain.copy(goals = goals, template = Template(listOf(square + square.first())))
        val program = Program.of("square.robo", "pen down\nforward 20\nturn left 60\nforward 45\n").asProject()
        services.editor.openProject(Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program)))))
        handle(RunEvent.RunPressed)
        advance(20_000)
        if (tab != null) handle(RunEvent.DrawerChosen(tab))
    }

    private fun solved(settings: Settings = Settings()): Workshop = workshop(settings).apply {
        handle(LearningEvent.TutorialStarted)
        handle(ProgramEvent.ProgramEdited(state.learning.tutorial!!.current.solution.text))
        handle(LearningEvent.TutorialFolded(true))
        handle(RunEvent.RunPressed)
        advance(30_000)
    }

    private fun workshop(settings: Settings) = runBlocking { openWorkshop() }.apply {
        handle(SettingsEvent.SettingsChanged(settings))
    }

    private fun Workshop.use(name: String, width: Int, height: Int, dark: Boolean = false) {
        photograph(this, width, height, dark).keepAs("outcome/$name")
        close()
    }
}
