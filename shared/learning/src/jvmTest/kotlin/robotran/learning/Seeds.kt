package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language

/** The solutions of the gallery's worlds that do not reach the goals with each of [seeds]. */
internal suspend fun unsolvedWorlds(seeds: IntRange): List<String> = worldTasks.flatMap { task ->
    task.solutions.flatMap { solution ->
        seeds.filterNot { runIn(task, solution, it).isSolved }.map { "${task.name}, ${solution.name}, seed $it" }
    }
}

/** The lessons that a pupil takes with a [brick]. */
internal fun lessonsOf(brick: BrickKind): List<Lesson> = Lessons.all.map { it.on(brick) }.filter { it.brick == brick }

/** The same for the lessons of a [brick]. Without deviations of the robot, a seed changes nothing. */
internal suspend fun unsolvedLessons(brick: BrickKind, seeds: IntRange): List<String> =
    lessonsOf(brick).filter { it.world(Language.ENGLISH).realism != 0.0 }.flatMap { lesson ->
        seeds.map { it to runInAllPlaces(lesson, lesson.solution.text, it) }.filterNot { (_, solved) ->
            solved.isSolved
        }
            .map { (seed, solved) -> "${lesson.name}, seed $seed: ${solved.run.goals}, ${solved.run.robot.pose}" }
    }
