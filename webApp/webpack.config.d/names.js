// What is in a file is in its name, so that a browser may keep it for ever: see docs/hosting.md.
config.output.chunkFilename = '[name].[contenthash:16].js';
config.output.assetModuleFilename = '[name].[contenthash:16][ext]';
