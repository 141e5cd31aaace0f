public class UncaughtException {
    static int[] numbers = {1, 2, 3};

    static int at(int place) {
        return numbers[place]; // fails ArrayIndexOutOfBoundsException
    }

    public static void main(String[] arguments) {
        for (int place = 0; ; place++) {
            System.out.println(at(place));
        }
    }
}

// It prints:
// expect 1
// expect 2
// expect 3
