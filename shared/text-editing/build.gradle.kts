plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.textediting.robolangExamples", "examples", "*.robo")
    constant("commonTest", "robotran.textediting.lejosExamples", "examples/lejos", "*.java")
    constant("commonTest", "robotran.textediting.nxjExamples", "examples/nxj", "*.java")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:robolang"))
            implementation(project(":shared:lego-firmware"))
            implementation(project(":shared:nqc"))
            implementation(project(":shared:lejos-library"))
            implementation(project(":shared:nxj-library"))
        }
    }
}
