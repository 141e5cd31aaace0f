plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant(
        "commonTest",
        "robotran.microbitlink.vectors",
        "shared/microbit-link/src/commonTest/resources/vectors",
        "*",
    )
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
            implementation(libs.coroutines.core)
        }
        commonTest {
            // A board at the other end of the wire, for the tests of all modules that talk to one.
            kotlin.srcDir("src/simulatedBoard/kotlin")
        }
    }
}
