package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.TaskProvider
import org.gradle.api.tasks.testing.Test
import org.gradle.language.base.plugins.LifecycleBasePlugin
import java.util.concurrent.Callable

/** Tasks that run a part of what another test task has on its class path. */
object TestParts {
    /** `thoroughTest`: what stands in packages with this segment is left out of [tests] and runs in `checkAll`. */
    private const val THOROUGH = "thorough"

    /** A task [name] that runs the classes of [tests] that match one of the patterns [classes]. */
    fun register(project: Project, tests: String, name: String, classes: List<String>): TaskProvider<Test> {
        val whole = project.tasks.named(tests, Test::class.java)
        return project.tasks.register(name, Test::class.java) { task ->
            task.group = LifecycleBasePlugin.VERIFICATION_GROUP
            // By a `Callable`, since a mapped provider would need that `tests` has run, and not only what it runs.
            task.testClassesDirs = project.files(Callable { whole.get().testClassesDirs })
            task.classpath = project.files(Callable { whole.get().classpath })
            classes.forEach(task.filter::includeTestsMatching)
        }
    }

    fun registerThorough(project: Project, tests: String) {
        if (project.fileTree(project.projectDir) { it.include("src/*/**/$THOROUGH/**/*.kt") }.isEmpty) return
        val classes = "*.$THOROUGH.*"
        project.tasks.named(tests, Test::class.java) { it.filter.excludeTestsMatching(classes) }
        val thorough = register(project, tests, "${THOROUGH}Test", listOf(classes))
        thorough.configure { it.description = "Runs the tests that take longer than they find, on the JVM." }
        Rings.addToAll(project, thorough)
    }
}
