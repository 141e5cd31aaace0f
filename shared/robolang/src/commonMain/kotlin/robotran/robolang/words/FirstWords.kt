package robotran.robolang.words

/** The keywords that begin a block. */
internal val OPENERS: Set<Keyword> = firstWords { it.isOpener }

/** Those that begin a block that may stand only outside all others. */
internal val OUTERMOST: Set<Keyword> = firstWords { it.isOutermost }

/** The words that a line of the header can begin with. */
internal val SETTINGS: Set<Keyword> = firstWords { it.isSetting }

private fun firstWords(isMeant: (LineForm) -> Boolean): Set<Keyword> =
    LineForm.entries.filter(isMeant).mapNotNullTo(mutableSetOf()) { form ->
        Vocabulary.ENGLISH.keyword(form.example.orEmpty().takeWhile { it.isLetter() })
    }
