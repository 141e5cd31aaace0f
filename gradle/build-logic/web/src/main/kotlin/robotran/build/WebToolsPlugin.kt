package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project

/** The tasks of the root project that install the tools for wasm and for the browser tests. */
class WebToolsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        WebTools.registerSetUp(project)
        WebTools.use(project)
        Chromium.registerSetUp(project)
        project.tasks.named("setUp") { it.dependsOn(WebTools.SET_UP_TASK, Chromium.SET_UP_TASK) }
    }
}
