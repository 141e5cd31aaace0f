plugins {
    id("robotran.jvm-app")
}

dependencies {
    api(project(":siteServer"))
    implementation(project(":shared:programs"))
    api(project(":shared:projects"))
    implementation(project(":shared:documents"))
    api(project(":shared:assignments"))
    implementation(project(":shared:desktop-tower"))
    implementation(libs.coroutines.core)
    implementation(libs.clikt)
    implementation(libs.mordant)
    implementation(libs.serialization.json)
    testImplementation(libs.commons.compress)
    testImplementation(project(":shared:lejos-library"))
}

application {
    mainClass.set("robotran.cli.MainKt")
    applicationName = "robotran"
}

kotlin {
    sourceSets {
        test {
            // The brick that the tests of send, firmware and brick talk to.
            kotlin.srcDir("../shared/tower/src/simulatedBrick/kotlin")
            kotlin.srcDir("../shared/tower/src/sharedTest/kotlin")
            // The hub that send talks to.
            kotlin.srcDir("../shared/hub-link/src/simulatedHub/kotlin")
            kotlin.srcDir("../siteServer/src/recordingConsole/kotlin")
        }
    }
}

tasks.test {
    // A test reads these sources: it looks for code that writes files by itself.
    inputs.dir(rootProject.file("desktopApp/src")).withPathSensitivity(PathSensitivity.RELATIVE)
    inputs.dir(rootProject.file("shared/desktop-tower/src")).withPathSensitivity(PathSensitivity.RELATIVE)
    inputs.dir(rootProject.file("shared/documents/src")).withPathSensitivity(PathSensitivity.RELATIVE)
    inputs.dir(rootProject.file("shared/ui/src")).withPathSensitivity(PathSensitivity.RELATIVE)
    inputs.dir(rootProject.file("shared/ui-common/src")).withPathSensitivity(PathSensitivity.RELATIVE)
    inputs.dir(rootProject.file("shared/workshop/src")).withPathSensitivity(PathSensitivity.RELATIVE)
}
