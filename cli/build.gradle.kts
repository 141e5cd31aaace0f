plugins {
    id("robotran.jvm-app")
}

dependencies {
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
        }
    }
}
