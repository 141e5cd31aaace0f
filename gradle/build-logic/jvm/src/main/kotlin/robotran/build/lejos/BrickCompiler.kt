package robotran.build.lejos

import org.gradle.api.Project
import org.gradle.api.artifacts.Configuration
import org.gradle.api.file.ConfigurableFileTree
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.TaskProvider
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import robotran.build.catalog
import robotran.build.texts.GenerateTexts

/** The configuration that publishes the class files of a brick library to other modules. */
internal const val BRICK_CLASSES = "brickClasses"

/** A resolvable configuration of files from the module [name]; the caller adds the dependency. */
internal fun resolvable(project: Project, name: String): Configuration = project.configurations.maybeCreate(name).also {
    it.isCanBeConsumed = false
    it.isCanBeResolved = true
}

/** A task that compiles [sources] with ECJ for [target], into `brick/` and [folder] in the build folder. */
internal fun compileForBrick(
    project: Project,
    name: String,
    folder: String,
    sources: Provider<ConfigurableFileTree>,
    target: BrickTarget,
    configure: (CompileForBrick) -> Unit,
): TaskProvider<CompileForBrick> {
    val compiler = resolvable(project, "brickCompiler")
    if (compiler.dependencies.isEmpty()) {
        project.dependencies.add(
            compiler.name,
            catalog(project).findLibrary("ecj").get(),
        )
    }
    return project.tasks.register(name, CompileForBrick::class.java) { task ->
        task.compiler.from(compiler)
        task.sources.set(sources)
        task.target.set(target)
        task.eachAlone.convention(false)
        task.classFolder.set(project.layout.buildDirectory.dir("brick/$folder/classes"))
        task.textFolder.set(project.layout.buildDirectory.dir("brick/$folder/texts"))
        configure(task)
    }
}

/**
 * Generates the constant [qualifiedName] in [sourceSet]: a map from the path of each class file of [compiled] to its
 * content in Base64.
 */
internal fun generateClassFiles(
    project: Project,
    compiled: TaskProvider<CompileForBrick>,
    qualifiedName: String,
    sourceSet: String,
) {
    val name = qualifiedName.substringAfterLast('.')
    val generate =
        project.tasks.register("generate" + name.replaceFirstChar(Char::uppercase), GenerateTexts::class.java) { task ->
            task.texts.set(compiled.map { made -> project.fileTree(made.textFolder) { it.builtBy(made) } })
            task.qualifiedName.set(qualifiedName)
            task.outputFolder.set(project.layout.buildDirectory.dir("generated/texts/$name"))
        }
    project.extensions.getByType(
        KotlinMultiplatformExtension::class.java,
    ).sourceSets.getByName(sourceSet).kotlin.srcDir(generate)
}

/** Publishes the class files of the library that [compiled] makes to other modules. */
internal fun publishClasses(project: Project, compiled: TaskProvider<CompileForBrick>) {
    project.configurations.create(BRICK_CLASSES) {
        it.isCanBeConsumed = true
        it.isCanBeResolved = false
        it.outgoing.artifact(compiled.flatMap { made -> made.classFolder })
    }
}
