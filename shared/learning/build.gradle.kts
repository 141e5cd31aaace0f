plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.learning.wordTexts", "learning/words", "*.md")
    constant("commonMain", "robotran.learning.tutorialTexts", "learning/tutorial", "**/*")
    constant("commonMain", "robotran.learning.worldTitleTexts", "learning/worlds", "*.md")
    constant("commonTest", "robotran.learning.robolangPages", "docs", "robolang.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
            api(project(":shared:projects"))
            implementation(project(":shared:lejos-library"))
        }
    }
}
