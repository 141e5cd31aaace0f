plugins {
    id("robotran.jvm-library")
}

dependencies {
    api(project(":shared:tower"))
    api(project(":shared:hub-link"))
    api(project(":shared:microbit-link"))
    implementation(libs.coroutines.core)
    implementation(libs.jserialcomm)
    testImplementation(libs.jna)
}

kotlin {
    sourceSets {
        test {
            // The brick at the other end of the pseudo-terminal.
            kotlin.srcDir("../tower/src/simulatedBrick/kotlin")
            kotlin.srcDir("../tower/src/sharedTest/kotlin")
            // The hub at that end.
            kotlin.srcDir("../hub-link/src/simulatedHub/kotlin")
        }
    }
}
