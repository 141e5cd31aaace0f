package robotran.learning
import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.programs.*
import robotran.projects.*
import robotran.robolang.Calibration
import robotran.world.*
import robotran.world.grade.runForGoals
import robotran.world.physics.loadPhysicsEngine
import kotlin.test.Test
class ProbeTest {
    @Test fun probe() = runTest {
        val reader = ProgramReader(Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE))
        val step = Tutorial.steps[6]
        val text = "repeat until light < 40\n forward 2\n show light\nend\nshow light\nwait 1 second\nrepeat 10 times\nforward 2\nshow light\nend\n"
        for (p in listOf(text, step.solution.text)) {
            val project = step.project(Language.ENGLISH, listOf(SourceFile("a.robo", p)))
            val loads = readRobotLoads(project, reader) as RobotLoads.Ready
            val s = Session(project.worldToRun, loads.loads, loadPhysicsEngine())
            s.pressRun()
            repeat(60) { s.advance(100); println("PROBE ${s.state.milliseconds} ${s.state.robot.pose} ${s.report().lcd}".take(220)) }
            println("PROBE ${s.state.brick.run}")
        }
    }
}
