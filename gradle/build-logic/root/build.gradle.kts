plugins {
    id("java-gradle-plugin")
}

// The plugins of the targets that this build configures. All modules share one class loader with them, as the Kotlin and
// Android plugins require.
dependencies {
    implementation(project(":jvm"))
    if (providers.systemProperty("robotran.targets").get().contains("compose")) {
        implementation(project(":compose"))
    }
    if (providers.systemProperty("robotran.targets").get().contains("wasm")) {
        implementation(project(":web"))
    }
    if (providers.systemProperty("robotran.targets").get().contains("android")) {
        implementation(project(":android"))
    }
}

gradlePlugin {
    testSourceSets()
    plugins {
        create("root") {
            id = "robotran.root"
            implementationClass = "robotran.build.RootPlugin"
        }
    }
}
