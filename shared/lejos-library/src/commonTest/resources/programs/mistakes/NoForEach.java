public class NoForEach {
    public static void main(String[] arguments) {
        int[] numbers = {1, 2};
        int sum = 0;
        for (int number : numbers) sum += number;
    }
}
// error 5
