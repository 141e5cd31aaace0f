package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.TaskProvider
import org.gradle.language.base.plugins.LifecycleBasePlugin

/** Makes Kotlin's wasm tasks of a module use [WebTools]. `check` runs its wasm tests in `wasmTests`. */
class WasmPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        WebTools.use(project)
        leaveOutOfCheck(project, "allTests", "wasmJsNodeTest", "wasmJsBrowserTest")
    }
}

/**
 * Takes [tasks], which Kotlin's plugin adds, out of a module's `check`. `allTests` is a report that runs the tests of all
 * targets; where a module has no wasm tests, it still links an empty program.
 */
internal fun leaveOutOfCheck(project: Project, vararg tasks: String) {
    // Kotlin's plugin adds the tasks late.
    project.gradle.projectsEvaluated {
        project.tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME) { check ->
            check.setDependsOn(check.dependsOn.filterNot { it is TaskProvider<*> && it.name in tasks })
        }
    }
}
