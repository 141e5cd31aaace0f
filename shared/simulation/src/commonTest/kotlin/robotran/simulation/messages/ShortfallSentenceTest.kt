package robotran.simulation.messages

import robotran.language.Language
import robotran.simulation.state.ForbiddenTouch
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.LineShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.simulation.state.RunMoment
import robotran.world.TouchKind
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals

class ShortfallSentenceTest {
    private val here = Point(10.0, 20.0)
    private val moment = RunMoment(12_480, here)

    @Test
    fun `what was missing is said with its figures`() {
        val sentences = mapOf(
            PlaceShortfall.NotReached(10.0, here, here, moment, "flag") to "10 cm short of the area \"flag\".",
            PlaceShortfall.PartlyOutside(2.31, true, here, moment, null) to
                "A part of it stuck out of the marked area by 2.4 cm.",
            PlaceShortfall.PartlyOutside(30.0, false, here, moment, null) to
                "30 cm more, and all of it would have been in the marked area.",
            PlaceShortfall.ReachedTooLate(1_510, moment, "flag") to
                "It got to the area \"flag\", but 1.6 s too late.",
            PlaceShortfall.LeftAgain(20.0, here, moment, null) to
                "It was in the marked area, but left it at 12.4 s. At the end it was 20 cm away.",
            PlaceShortfall.Entered(moment, null) to "It was in the marked area at 12.4 s.",
            PlaceShortfall.Left(1.0, moment, null) to "It left the marked area at 12.4 s.",
            ForbiddenTouch(setOf(TouchKind.BLOCKS, TouchKind.WALLS), null, moment) to
                "It touched a wall and a block at 12.4 s.",
            ForbiddenTouch(setOf(TouchKind.BARRIERS), "post", moment) to
                "It touched the barrier \"post\" at 12.4 s.",
            InkShortfall.TooShort(0.01, here) to "The drawing is 0.1 cm too short.",
            InkShortfall.TooLong(30.0, moment) to
                "The drawing was long enough at 12.4 s. After that, 30 cm too much was drawn.",
            InkShortfall.TemplateMissing(0.189, 0.9, emptyList()) to
                "18 % of the drawing is traced, and 90 % is needed.",
            InkShortfall.InkBesideTemplate(17.0, emptyList(), moment) to
                "17 cm of ink is beside the drawing. That is too much.",
            LineShortfall.NotReached(5.0, here, moment) to
                "The light sensor never found the line. It came as close as 5 cm.",
            LineShortfall.Left(0.62, 30.0, false, moment) to "The line was left at 12.4 s, after 62 % of the way.",
            LineShortfall.Left(0.1, 30.0, true, moment) to
                "The line was left at 12.4 s and found again somewhere else, so the way began again there.",
            LineShortfall.Unfinished(0.5, 30.0, moment) to "50 % of the way along the line is done.",
            LineShortfall.TooLate(2_000, moment) to "The whole way along the line is done, but 2 s too late.",
            ProgramShortfall.StillRunning(moment) to "The program was still running at 12.4 s.",
            ProgramShortfall.EndedTooLate(500, moment) to "The program came to its end 0.5 s too late.",
            ProgramShortfall.DisplayDiffered("5", null, null, null) to
                "The program showed nothing on the display, and \"5\" is needed.",
            ProgramShortfall.DisplayDiffered("5", "6 1", "6", moment) to
                "The display showed \"6\", and \"5\" is needed.",
            ProgramShortfall.DisplayDiffered("HELLO", "1", "HELL", moment) to
                "At 12.4 s the display showed \"HELL\". That is near, but \"HELLO\" is needed.",
            ProgramShortfall.DisplayChanged("4", "8", moment) to
                "The display showed \"4\" up to 12.4 s. At the end it shows \"8\".",
            ProgramShortfall.DisplayChanged("4", null, moment) to
                "The display showed \"4\" up to 12.4 s. At the end it is empty.",
            ProgramShortfall.TooManyTones(6, 4, moment) to "6 tones were played, and 4 are needed.",
            ProgramShortfall.TonesMissing(1, 3, 0, null, null) to "1 of 3 tones were played.",
            ProgramShortfall.TonesMissing(0, 3, 2, 880.2, moment) to
                "0 of 3 tones were played. 2 others were too high or too low: the first had 880 hertz.",
        )
        for ((shortfall, expected) in sentences) {
            assertEquals(expected, SimulationMessages.of(Language.ENGLISH).sentenceFor(shortfall))
        }
    }

    @Test
    fun `a group is told by its decisive part`() {
        val group = GoalShortfall.PartNotMet(2, GoalShortfall.PartNotMet(0, ProgramShortfall.NotStarted))
        assertEquals("The program was not started.", SimulationMessages.of(Language.ENGLISH).sentenceFor(group))
    }

    @Test
    fun `decimals have a comma in German and Spanish`() {
        val late = ProgramShortfall.EndedTooLate(1_500, moment)
        assertEquals(
            "Das Programm war 1,5 s zu spät zu Ende.",
            SimulationMessages.of(Language.GERMAN).sentenceFor(late),
        )
        assertEquals("El programa terminó 1,5 s tarde.", SimulationMessages.of(Language.SPANISH).sentenceFor(late))
    }
}
