plugins {
    id("robotran.compose")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.ui.exampleTexts", "examples", "*.robo")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:robolang"))
            api(project(":shared:world"))
            api(libs.compose.runtime)
            api(libs.compose.foundation)
            api(libs.compose.material3)
            api(libs.compose.ui)
            implementation(libs.compose.resources)
            implementation(libs.coroutines.core)
        }
        jvmTest.dependencies {
            implementation(libs.kotest.property)
        }
    }
}

compose.resources {
    packageOfResClass = "robotran.ui.resources"
}
