package robotran.robolang

/**
 * The table of everything Robolang says to a learner, one function a message. Another language is another implementation.
 * Words of the program arrive as they were typed, already shortened.
 */
interface RobolangMessages :
    SyntaxMessages,
    MeaningMessages,
    WarningMessages,
    RunMessages
