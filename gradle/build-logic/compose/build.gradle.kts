plugins {
    id("java-gradle-plugin")
    id("org.jetbrains.kotlin.jvm")
}

dependencies {
    implementation(project(":jvm"))
    api(libs.plugin.compose)
    implementation(libs.plugin.kotlin.compose)
}

gradlePlugin {
    testSourceSets()
    plugins {
        create("compose") {
            id = "robotran.compose"
            implementationClass = "robotran.build.ComposePlugin"
        }
        create("desktop") {
            id = "robotran.desktop"
            implementationClass = "robotran.build.DesktopPlugin"
        }
    }
}
