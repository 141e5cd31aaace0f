plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    packed("commonMain", "robotran.learning.wordTexts", "learning/words", "*.md")
    packed("commonMain", "robotran.learning.lessonTexts", "learning/lessons", "*/*/*")
    constant("commonMain", "robotran.learning.commonLessonTexts", "learning/lessons", "*.md")
    constant("commonMain", "robotran.learning.worldLevels", "learning/worlds", "*.md")
    packed("commonMain", "robotran.learning.worldTaskTexts", "learning/worlds", "*/*")
    constant("jvmTest", "robotran.learning.wrongTries", "learning/lessons", "*/*/wrong/*")
    constant("jvmTest", "robotran.learning.wrongTriesInWorlds", "learning/worlds", "*/wrong/*")
    constant("jvmTest", "robotran.learning.catalogues", "shared", "*/src/commonMain/messages/*.md")
    constant("jvmTest", "robotran.learning.pageOnWords", "docs", "messages.md")
    constant("commonTest", "robotran.learning.robolangPages", "docs", "robolang.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
            api(project(":shared:projects"))
            api(project(":shared:simulation"))
            implementation(project(":shared:lejos-library"))
            implementation(project(":shared:lego-firmware"))
            implementation(project(":shared:nqc"))
            implementation(project(":shared:nxj-library"))
            implementation(project(":shared:rcx-rom"))
        }
    }
}
