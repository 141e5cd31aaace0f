plugins {
    id("robotran.core")
    id("robotran.texts")
    id("robotran.nxj-library")
}

texts {
    constant("jvmTest", "robotran.nxjlibrary.documentedNatives", "shared/nxj-library/src/brick", "natives.md")
    constant("jvmTest", "robotran.nxjlibrary.comparison", "shared/nxj-library", "CompareApi.java")
    constant(
        "jvmTest",
        "robotran.nxjlibrary.testPrograms",
        "shared/nxj-library/src/commonTest/resources/programs",
        "**/*.java",
    )
}

kotlin {
    sourceSets {
        jvmTest.dependencies {
            implementation(libs.bcel)
            implementation(libs.ecj)
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
