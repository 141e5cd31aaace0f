package robotran.build

import org.gradle.api.Project
import org.gradle.language.base.plugins.LifecycleBasePlugin

/**
 * The rings of checks, each a task of every project, so that its name alone selects it in the whole tree: [QUICK] after a
 * change, Gradle's own `check`, and [CHECK_ALL]. Tests state their ring by where they stand, see `docs/testing.md`.
 */
object Rings {
    private const val QUICK = "quick"
    private const val CHECK_ALL = "checkAll"

    fun register(root: Project) = root.allprojects { project ->
        project.tasks.register(QUICK) { task ->
            task.group = LifecycleBasePlugin.VERIFICATION_GROUP
            task.description = "What tells in a few minutes whether a change is good: style and tests on the JVM."
        }
        project.tasks.register(CHECK_ALL) { task ->
            task.group = LifecycleBasePlugin.VERIFICATION_GROUP
            task.description = "All that check runs, and all that takes longer than it finds. It takes hours."
        }
        project.plugins.withType(LifecycleBasePlugin::class.java) {
            project.tasks.named(CHECK_ALL) { it.dependsOn(LifecycleBasePlugin.CHECK_TASK_NAME) }
        }
    }

    /** [checks] of [project] run in all rings, if something else has them in `check`. */
    fun addToQuick(project: Project, vararg checks: Any) {
        project.tasks.named(QUICK) { it.dependsOn(*checks) }
    }

    /** [checks] of [project] run in the largest ring only. */
    fun addToAll(project: Project, vararg checks: Any) {
        project.tasks.named(CHECK_ALL) { it.dependsOn(*checks) }
    }
}
