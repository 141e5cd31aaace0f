plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant(
        "commonTest",
        "robotran.programs.robolangPrograms",
        "shared/robolang/src/commonTest/resources/programs",
        "**/*.robo",
    )
    constant("commonTest", "robotran.programs.robolangExamples", "examples", "*.robo")
    constant("commonTest", "robotran.programs.lejosExamples", "examples/lejos", "*.java")
    constant("commonTest", "robotran.programs.nxjExamples", "examples/nxj", "*.java")
    constant("commonTest", "robotran.programs.nxjRuns", "shared/programs/src/commonTest/resources/nxj-runs", "*")
    constant("commonTest", "robotran.programs.nqcExamples", "examples/nqc", "*.nqc")
    constant("commonTest", "robotran.programs.nqcRuns", "shared/programs/src/commonTest/resources/nqc-runs", "*")
    constant("commonTest", "robotran.programs.expectedRuns", "shared/programs/src/commonTest/resources/runs", "*")
    constant(
        "commonTest",
        "robotran.programs.brickPrograms",
        "shared/programs/src/commonTest/resources/brick",
        "*.java",
    )
    constant("jvmTest", "robotran.programs.nqcPrograms", "shared/nqc/src/commonTest/resources/vectors", "*.nqc")
    constant("jvmTest", "robotran.programs.solutions", "learning/worlds", "*/solution.*")
    constant("jvmTest", "robotran.programs.imageDocument", "docs", "lejos-image.md")
    constant(
        "commonTest",
        "robotran.programs.originalRuns",
        "shared/programs/src/commonTest/resources/original",
        "*.txt",
    )
    constant(
        "commonTest",
        "robotran.programs.vectorFiles",
        "shared/lejos-linker/src/commonTest/resources/vectors",
        "*.txt",
    )
    constant("jvmTest", "robotran.programs.lejosDocument", "docs", "lejos.md")
    blocks("jvmTest", "robotran.programs.documentedPrograms", "docs", "lejos.md", "java")
    blocks("jvmTest", "robotran.programs.documentedNxjPrograms", "docs", "nxj.md", "java")
    constant(
        "jvmTest",
        "robotran.programs.libraryPrograms",
        "shared/lejos-library/src/commonTest/resources/programs",
        "**/*.java",
    )
    constant(
        "jvmTest",
        "robotran.programs.nxjPrograms",
        "shared/nxj-library/src/commonTest/resources/programs",
        "**/*.java",
    )
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:robolang"))
            api(project(":shared:tinyvm"))
            api(project(":shared:java-compiler"))
            api(project(":shared:lejos-linker"))
            api(project(":shared:lego-firmware"))
            api(project(":shared:nqc"))
            implementation(project(":shared:lejos-library"))
            implementation(project(":shared:nxj-library"))
        }
        commonTest.dependencies {
            implementation(project(":shared:simulation"))
        }
        jvmTest {
            kotlin.srcDir("../tinyvm/src/nxjExpectations/kotlin")
        }
    }
}
