import josx.platform.rcx.LCD;

public class StoredCharsAreLikeShort {
    static char shared;
    char own;

    public static void main(String[] arguments) {
        char[] letters = new char[2];
        letters[1] = '\uffff';
        shared = '\ufffe';
        StoredCharsAreLikeShort object = new StoredCharsAreLikeShort();
        object.own = '\u8000';
        LCD.showNumber(letters[1] < 0 ? 1 : 0); // brick shows: 1 // forgiving shows: 0
        LCD.showNumber(shared < 0 ? 1 : 0); // brick shows: 1 // forgiving shows: 0
        LCD.showNumber(object.own < 0 ? 1 : 0); // brick shows: 1 // forgiving shows: 0
        LCD.showNumber((letters[1] & 0xffff) / 10); // shows: 6553
    }
}
