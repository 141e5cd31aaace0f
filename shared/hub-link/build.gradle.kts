plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant(
        "commonTest",
        "robotran.hublink.recordedDialogues",
        "shared/hub-link/src/commonTest/resources/dialogues",
        "*.txt",
    )
    constant("commonTest", "robotran.hublink.vectors", "shared/hub-link/src/commonTest/resources/vectors", "*.txt")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
            implementation(libs.coroutines.core)
        }
        commonTest {
            // A hub at the other end of the wire, for the tests of all modules that talk to one.
            kotlin.srcDir("src/simulatedHub/kotlin")
        }
    }
}
