plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.javacompiler.librarySources", "shared/lejos-library/src/brick/java", "**/*.java")
    constant(
        "commonTest",
        "robotran.javacompiler.testPrograms",
        "shared/lejos-library/src/commonTest/resources/programs",
        "**/*.java",
    )
    constant("commonTest", "robotran.javacompiler.examplePrograms", "examples/lejos", "*.java")
    constant("commonTest", "robotran.javacompiler.nxjExamplePrograms", "examples/nxj", "*.java")
    constant(
        "commonTest",
        "robotran.javacompiler.nxjPrograms",
        "shared/nxj-library/src/commonTest/resources/programs",
        "**/*.java",
    )
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
            api(project(":shared:language-support"))
            api(project(":shared:lejos-library"))
            implementation(project(":shared:nxj-library"))
        }
        jvmMain.dependencies {
            implementation(libs.coroutines.core)
            implementation(project(":shared:ecj"))
        }
        jvmTest.dependencies {
            // A test compares its constants with ours; the compiler itself comes from shared/ecj.
            compileOnly(libs.ecj)
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
